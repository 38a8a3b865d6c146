#pragma once

namespace ljmd {

/// While one of these lives, GSL returns errors as codes: its own handler would abort the program. The handler that was
/// there before the first one is set again when the last one has gone, whichever thread it is in.
class GslErrorCodes {
  public:
    GslErrorCodes();
    ~GslErrorCodes();
    GslErrorCodes(const GslErrorCodes&) = delete;
    GslErrorCodes& operator=(const GslErrorCodes&) = delete;
};

}  // namespace ljmd

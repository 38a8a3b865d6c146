#pragma once

namespace ljmd {

/// While an object of this class exists, GSL returns errors as codes. Otherwise GSL's default handler would abort the
/// program. Objects are counted over all threads: the first one saves the handler of the program, the last one restores
/// it.
class GslErrorCodes {
  public:
    GslErrorCodes();
    ~GslErrorCodes();
    GslErrorCodes(const GslErrorCodes&) = delete;
    GslErrorCodes& operator=(const GslErrorCodes&) = delete;
};

}  // namespace ljmd

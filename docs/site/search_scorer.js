// Order and excerpts of what the search finds, by the texts of all pages (PAGE_TEXTS, see search_texts.py). Sphinx has two scores for a
// page, one for a word in a heading and one for a word anywhere, and reads pages for their excerpts, which a browser forbids on a disk.

const QUERY = splitQuery((new URLSearchParams(window.location.search).get("q") || "").toLowerCase()).filter((word) => !stopwords.includes(word));
const WORDS = QUERY.map((word) => {
  const stem = new Stemmer().stemWord(word);
  return new RegExp(`(?<![\\p{L}\\p{N}])(?:${_escapeRegExp(word)}|${_escapeRegExp(stem)})`, "giu");
});
const hits = (text) => WORDS.map((word) => (text.match(word) || []).length);
const holdsAll = (text) => hits(text).every((count) => count > 0);

/** The section to show: one whose heading has all words, or the one with most of them. */
const bestSection = (docName) => {
  let best = null;
  for (const [anchor, heading, text] of PAGE_TEXTS[docName] || []) {
    const found = hits(text);
    const score = 100 * holdsAll(heading) + 20 * found.filter((count) => count > 0).length + found.reduce((sum, count) => sum + count, 0);
    if (score > 0 && (best === null || score > best.score)) best = { anchor, heading, text, score };
  }
  return best;
};

// Titles first, then the glossary, headings, names of classes and functions; then pages by how often they have the rarest word.
Scorer.score = ([docName, title, anchor, description, score]) => {
  if (description) return QUERY.length === 1 && title.toLowerCase().split(/[.:]/).pop() === QUERY[0] && !description.includes("parameter") ? 30 : 0;
  if (anchor) return 40 + score / 10;
  const sections = PAGE_TEXTS[docName] || [];
  const text = sections.map((section) => section[2]).join(" ");
  const often = Math.min(...hits(text));
  const inHeading = sections.slice(1).some((section) => holdsAll(section[1]));
  const asPhrase = QUERY.length > 1 && text.toLowerCase().includes(QUERY.join(" "));
  return 100 * holdsAll(title) + 60 * (docName === "glossary" && often > 0) + 30 * inHeading + 15 * asPhrase + 5 * Math.log2(1 + often) -
         10 * (docName === "site/changelog");
};

// Instead of the page, which a browser may not read, its address: it is all that the excerpt below needs.
window.fetch = async (url) => ({ text: async () => decodeURI(url) });

Search.makeSearchSummary = (url) => {
  const docName = url.slice(DOCUMENTATION_OPTIONS.URL_ROOT.length, -DOCUMENTATION_OPTIONS.FILE_SUFFIX.length);
  const section = bestSection(docName);
  const summary = document.createElement("p");
  summary.classList.add("context");
  if (section === null) return summary;
  if (section.anchor !== PAGE_TEXTS[docName][0][0]) {
    const link = summary.appendChild(document.createElement("a"));
    link.href = `${url}#${section.anchor}`;
    link.textContent = section.heading;
    summary.append(": ");
  }
  const places = WORDS.map((word) => section.text.search(word)).filter((place) => place >= 0);
  const start = Math.max(0, (places.length > 0 ? Math.min(...places) : 0) - 80);
  const begin = start > 0 ? section.text.indexOf(" ", start) + 1 : 0;
  const text = section.text.slice(begin, begin + 240);
  const end = begin + 240 < section.text.length ? text.lastIndexOf(" ") : text.length;
  summary.append(`${begin > 0 ? "... " : ""}${text.slice(0, end)}${end < text.length ? " ..." : ""}`);
  return summary;
};

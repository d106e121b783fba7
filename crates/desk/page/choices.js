// The meaning of a choice beside its word: the first clause of its help.

/** The first clause of a help text. */
export const meaning = (help) => /^(.*?)[.;:](?=\s|$)/s.exec(help)?.[1] ?? help;

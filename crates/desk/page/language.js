// The language of the page, as the shell has set it.

export const language = () => (document.documentElement.lang === 'de' ? 'de' : 'en');

// Sets the theme before the first paint, so that a dark desk does not flash white. A classic script: modules run too late.
(function () {
  let theme = null;
  try {
    theme = localStorage.getItem('desk.theme');
  } catch { /* Storage may be blocked: the cookie or the default remains. */ }
  const cookie = document.cookie.match(/(?:^|; )desk-theme=([a-z]+)/);
  document.documentElement.dataset.theme = theme || (cookie ? cookie[1] : 'auto');
})();

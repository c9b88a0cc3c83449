// Before anything is painted: the palette of before, so that a reload at night does not flash.
document.documentElement.dataset.palette = new URLSearchParams(location.search).get('palette') ?? localStorage.getItem('palette') ?? 'day';

(() => {
  const frames = JSON.parse(document.getElementById('motion-data').textContent);
  const root = document.getElementById('motion');
  const slider = document.getElementById('motion-time');
  const said = document.getElementById('motion-said');
  const lines = [...root.querySelectorAll('.live polyline')];
  const show = () => {
    const [time, ...points] = frames[slider.value];
    lines.forEach((line, k) => line.setAttribute('points', points[k]));
    said.textContent = time;
    slider.setAttribute('aria-valuetext', time);
  };
  slider.addEventListener('input', show);
  root.classList.add('scripted');
  show();
})();

#include "watch_state.hpp"

namespace arenite::app {

// It stands by itself: no file, font or script from anywhere.
std::string watch_page() {
  return R"page(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Arenite</title><style>
:root{color-scheme:light dark;--ink:#1b1b1b;--paper:#fff;--faint:#8886;--bar:#3b6ea5}
@media(prefers-color-scheme:dark){:root{--ink:#e8e8e8;--paper:#161616;--bar:#7aa7d6}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper)}
body{max-width:60rem;margin:2rem auto;padding:0 1rem}
h1{font-size:1.3rem;margin:0}#where{margin:.2rem 0 1rem;opacity:.7}
#bar{height:.8rem;border:1px solid var(--faint);border-radius:.4rem;overflow:hidden}
#bar div{height:100%;width:0;background:var(--bar)}
ol{padding-left:1.4rem}button{font:inherit;padding:.2rem .9rem}.charts{display:flex;flex-wrap:wrap;gap:1rem}
figure{margin:0;flex:1 1 26rem}svg{width:100%;height:auto;border:1px solid var(--faint)}
text{fill:var(--ink);font-size:11px}
.left{stroke:#c1272d;fill:#c1272d}.right{stroke:#e08214;fill:#e08214}
.bottom{stroke:#3b6ea5;fill:#3b6ea5}.top{stroke:#1a9850;fill:#1a9850}
path{fill:none!important;stroke-width:1.5}text.left,text.right,text.bottom,text.top{stroke:none}
</style></head><body>
<h1 id="title">Arenite</h1><p id="where"></p>
<div id="bar" role="progressbar" aria-valuemin="0" aria-valuemax="100"><div></div></div>
<p id="now" aria-live="polite"></p><p><a id="page" href="page" hidden>Full page of the finished stages</a></p>
<p><button id="stop" hidden>Stop the run</button> <span id="answer"></span></p><ol id="stages"></ol>
<div class="charts"><figure id="force"></figure><figure id="position"></figure></div>
<script>
const at = (id) => document.getElementById(id), sides = ['left', 'right', 'bottom', 'top'];
const span = (s) => s < 90 ? Math.round(s) + ' s' :
  s < 5400 ? Math.round(s / 60) + ' min' : (s / 3600).toFixed(1) + ' h';
const lives = {running: 'running', stopped: 'stopped; the same command continues from the checkpoint',
  died: 'its process has ended; the same command continues from the last checkpoint',
  unknown: 'no status for a minute', waiting: 'not started', ended: 'ended'};

// One curve per wall against time; scale and unit follow from the largest value.
function chart(place, name, unit, curves) {
  const shown = sides.filter((s) => curves[s + '_' + name]), time = curves.time;
  const all = shown.flatMap((s) => curves[s + '_' + name]).filter((v) => v !== null);
  if (all.length < 2 || time.length < 2) { place.textContent = ''; return; }
  const W = 520, H = 260, l = 64, r = 8, t = 22, b = 26;
  const low = Math.min(0, ...all), high = Math.max(...all, low + 1e-12), end = time.at(-1), begin = time[0];
  const x = (v) => l + (W - l - r) * (v - begin) / (end - begin || 1);
  const y = (v) => H - b - (H - t - b) * (v - low) / (high - low || 1);
  const pen = (v, k) => k && v[k - 1] !== null ? 'L' : 'M';
  const step = (v, k) => v[k] === null ? '' : pen(v, k) + x(time[k]).toFixed(1) + ' ' + y(v[k]).toFixed(1);
  const path = (v) => v.map((q, k) => step(v, k)).join('');
  place.innerHTML = `<svg viewBox="0 0 ${W} ${H}" role="img" aria-label="${name} of the walls against time">` +
    shown.map((s, k) => `<path class="${s}" d="${path(curves[s + '_' + name])}"/>` +
      `<text class="${s}" x="${l + 90 + 60 * k}" y="14">${s}</text>`).join('') +
    `<text x="4" y="14">${name} [${unit}]</text>` +
    `<text x="${l - 4}" y="${t + 4}" text-anchor="end">${high.toPrecision(3)}</text>` +
    `<text x="${l - 4}" y="${H - b}" text-anchor="end">${low.toPrecision(3)}</text>` +
    `<text x="${l}" y="${H - 8}">${begin.toPrecision(3)} s</text>` +
    `<text x="${W - r}" y="${H - 8}" text-anchor="end">${end.toPrecision(4)} s</text></svg>`;
}

function show(s) {
  at('title').textContent = s.title || s.folder;
  at('where').textContent = s.folder + ': ' + (lives[s.life] || s.life);
  const q = s.status, share = s.life === 'ended' ? 1 : q ? q.share : 0;
  at('bar').firstChild.style.width = 100 * share + '%';
  at('bar').setAttribute('aria-valuenow', Math.round(100 * share));
  at('now').textContent = !q ? '' : `stage ${q.stage + 1} of ${q.stages}, ${q.name}` +
    (q.increments > 1 ? `, increment ${q.increment} of ${q.increments}` : '') +
    (q.settles ? `: ${(100 * share).toFixed(0)} %` : ': does not settle') +
    (q.step ? `, ${q.field ? 'iteration' : 'step'} ${q.step}` : '') +
    (s.life === 'running' && q.seconds_left !== null ? `, about ${span(q.seconds_left)} left` : '');
  at('page').hidden = s.stages.length === 0;
  at('stop').hidden = s.life !== 'running';
  at('stages').replaceChildren(...s.stages.map((one) => {
    const li = document.createElement('li');
    li.textContent = one.name + ': ' + one.outcome;
    return li;
  }));
  chart(at('force'), 'force', 'N', s.curves);
  chart(at('position'), 'position', 'm', s.curves);
}

at('stop').onclick = async () => {
  const answer = await fetch('stop', {method: 'POST'});
  at('answer').textContent = answer.ok ? 'stop requested; the run writes its checkpoint and exits'
    : 'it is no longer running';
};
let missed = 0;
async function ask() {
  try {
    show(await (await fetch('state')).json());
    missed = 0;
  } catch (_) {
    if (++missed > 2) at('where').textContent = 'this page is no longer served; `arenite watch FOLDER` serves it again';
  }
  setTimeout(ask, 1000);
}
ask();
</script></body></html>
)page";
}

}  // namespace arenite::app

// The animation: bodies by their centrelines, frame by frame, the deformation times what the slider says.
"use strict";
(function () {
  const data = JSON.parse(document.getElementById("data").textContent);
  const byId = (id) => document.getElementById(id);
  const [scene, strips, play, time, zoom] = ["scene", "strips", "play", "time", "zoom"].map(byId);
  const frames = data.time.length;
  const viridis = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];
  const curves = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
  let frame = 0, factor = data.zoom, playing = false, started = 0, view = null;

  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);

  function mix(part) {  // 0 to 1 along viridis
    const at = Math.min(Math.max(part, 0), 1) * (viridis.length - 1), k = Math.min(Math.floor(at), viridis.length - 2);
    const channel = (hex, i) => parseInt(hex.slice(1 + 2 * i, 3 + 2 * i), 16);
    return "rgb(" + [0, 1, 2].map((i) => Math.round(channel(viridis[k], i) * (k + 1 - at) +
                                                    channel(viridis[k + 1], i) * (at - k))) + ")";
  }

  function centreline(body, f, share) {  // share: of the deformation that the film has
    const rest = body.rest[f], off = body.deformation[f], points = [];
    for (let i = 0; i < rest.length; i += 2) {
      points.push([rest[i] * data.unit + share * off[i] * data.deformation_unit,
                   rest[i + 1] * data.unit + share * off[i + 1] * data.deformation_unit]);
    }
    return points;
  }

  function pairs(line) {  // x and y in turn, in units
    const points = [];
    for (let i = 0; i < line.length; i += 2) { points.push([line[i] * data.unit, line[i + 1] * data.unit]); }
    return points;
  }

  const share = () => data.zoom > 0 ? factor / data.zoom : 0;

  function fit() {  // everything in all frames, with a margin
    let low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (const body of data.bodies) {
      for (let f = 0; f < frames; f++) {
        for (const p of centreline(body, f, share())) {
          for (let i = 0; i < 2; i++) { low[i] = Math.min(low[i], p[i]); high[i] = Math.max(high[i], p[i]); }
        }
      }
    }
    const beside = data.hinges.filter((hinge) => hinge.body < 0).flatMap((hinge) => hinge.x.map((x, f) =>
      [x * data.unit, hinge.y[f] * data.unit]));
    for (const p of data.backdrop.flatMap(pairs).concat(beside)) {
      for (let i = 0; i < 2; i++) { low[i] = Math.min(low[i], p[i]); high[i] = Math.max(high[i], p[i]); }
    }
    const margin = 0.12 * Math.max(high[0] - low[0], high[1] - low[1]), room = data.forces.length ? 2 * margin : margin;
    view = { low: low.map((v) => v - room), high: high.map((v) => v + room), symbol: margin / 3 };
  }

  function prepared(canvas) {  // at the screen's own pixels
    const ratio = window.devicePixelRatio || 1, box = canvas.getBoundingClientRect();
    canvas.width = Math.round(box.width * ratio);
    canvas.height = Math.round(box.height * ratio);
    const c = canvas.getContext("2d");
    c.scale(ratio, ratio);
    c.lineJoin = "round";
    return [c, box.width, box.height];
  }

  function path(c, points) {
    c.beginPath();
    points.forEach((p, i) => i ? c.lineTo(p[0], p[1]) : c.moveTo(p[0], p[1]));
  }

  function sides(points, half) {  // the body's two edges
    const edge = [[], []];
    points.forEach((p, i) => {
      const a = points[Math.max(i - 1, 0)], b = points[Math.min(i + 1, points.length - 1)];
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1,
          n = [-(b[1] - a[1]) / length * half, (b[0] - a[0]) / length * half];
      edge[0].push([p[0] + n[0], p[1] + n[1]]);
      edge[1].push([p[0] - n[0], p[1] - n[1]]);
    });
    return edge;
  }

  function drawScene() {
    const [c, width, height] = prepared(scene);
    const scale = Math.min(width / (view.high[0] - view.low[0]), height / (view.high[1] - view.low[1]));
    const middle = [0, 1].map((i) => (view.low[i] + view.high[i]) / 2);
    const at = (p) => [width / 2 + (p[0] - middle[0]) * scale, height / 2 - (p[1] - middle[1]) * scale];
    const ink = colour("--ink"), soft = colour("--soft");
    const lines = data.bodies.map((body) => centreline(body, frame, share()));

    c.strokeStyle = colour("--line");
    c.lineWidth = 1;
    data.backdrop.forEach((line) => { path(c, pairs(line).map(at)); c.stroke(); });
    c.strokeStyle = soft;
    c.lineWidth = 1.2;
    c.setLineDash([5, 5]);
    data.bodies.forEach((body) => { path(c, centreline(body, frame, 0).map(at)); c.stroke(); });
    c.setLineDash([]);
    const last = data.bodies[data.bodies.length - 1];
    if (last) {
      const trail = [];
      for (let f = 0; f <= frame; f++) { trail.push(at(centreline(last, f, share()).pop())); }
      path(c, trail);
      c.stroke();
    }
    data.bodies.forEach((body, b) => {
      const points = lines[b].map(at), edge = sides(points, Math.max(body.half_height * scale, 1.5));
      for (let i = 0; i + 1 < points.length; i++) {
        c.fillStyle = c.strokeStyle = body.stress ? mix(body.stress[frame][i] / 255) : curves[5];
        path(c, [edge[0][i], edge[0][i + 1], edge[1][i + 1], edge[1][i]]);
        c.closePath();
        c.fill();
        c.stroke();
      }
      c.strokeStyle = ink;
      c.lineWidth = 0.8;
      path(c, edge[0].concat(edge[1].slice().reverse()));
      c.closePath();
      c.stroke();
    });
    const size = view.symbol * scale;
    const placed = (point) => at(point.body < 0 ? [point.x[frame] * data.unit, point.y[frame] * data.unit] :
                                 lines[point.body][point.point]);
    c.strokeStyle = ink;
    c.lineWidth = 1.3;
    data.springs.forEach((spring) => {
      const p = placed(spring.from);
      path(c, spring.shape === "coil" ? coil(p, placed(spring.to), size) : spiral(p, size));
      c.stroke();
    });
    data.hinges.forEach((hinge) => {
      const p = placed(hinge);
      if (hinge.ground) {
        const wall = hinge.shape === "weld";
        ground(c, turned(p, wall ? hinge.angle[frame] : 0, size), wall);
      }
      c.fillStyle = colour("--paper");
      outline(c, turned(p, hinge.angle[frame], size), hinge.shape);
      c.fill();
      c.stroke();
    });
    data.forces.forEach((force) => drawForce(c, placed(force), [force.F_x[frame], -force.F_y[frame]], 6 * size));
    if (data.moment && data.hinges.length) {
      drawMoment(c, placed(data.hinges[0]), data.moment[frame], 2.6 * size);
    }
    data.moments.forEach((moment) => drawMoment(c, placed(moment), moment.M[frame], 2.6 * size));
    if (data.gravity) { drawGravity(c, width, Math.sign(data.gravity), ink); }
  }

  function coil(from, to, size) {  // as spring_symbol.m
    const way = [to[0] - from[0], to[1] - from[1]], length = Math.hypot(...way) || 1, points = [from];
    const place = (along, aside) => points.push([from[0] + along * way[0] - aside * size * way[1] / length,
                                                 from[1] + along * way[1] + aside * size * way[0] / length]);
    place(0.15, 0);
    for (let k = 1; k <= 12; k++) { place(0.15 + 0.7 * (k - 0.5) / 12, k % 2 ? 0.45 : -0.45); }
    place(0.85, 0);
    return [...points, to];
  }

  function spiral(p, size) {
    return Array.from({ length: 61 }, (_, k) => {
      const angle = 5 * Math.PI * k / 60, r = (0.4 + 0.7 * k / 60) * size;
      return [p[0] + r * Math.cos(angle), p[1] - r * Math.sin(angle)];
    });
  }

  function turned(p, angle, size) {  // symbols of size 1, as hinge_symbol.m
    const k = size * Math.cos(angle), s = size * Math.sin(angle);
    return ([x, y]) => [p[0] + k * x - s * y, p[1] - s * x - k * y];
  }

  function outline(c, place, shape) {
    const angles = Array.from({ length: 25 }, (_, k) => Math.PI * k / 12);
    const round = (r) => angles.map((angle) => [r * Math.cos(angle), r * Math.sin(angle)]);
    const box = (w, h) => [[w, h], [-w, h], [-w, -h], [w, -h], [w, h]];
    path(c, { pin: round(0.4), hub: round(0.9), block: box(0.9, 0.6), weld: box(0.3, 0.3) }[shape].map(place));
  }

  function ground(c, place, wall) {
    path(c, (wall ? [[0, -1.4], [0, 1.4]] : [[0, 0], [-1, -1.6], [1, -1.6], [0, 0]]).map(place));
    for (let foot = -1; foot <= 1.4; foot += 0.6) {
      const line = wall ? [[0, foot], [-0.5, foot - 0.5]] : [[foot, -1.6], [foot - 0.5, -2.1]];
      c.moveTo(...place(line[0]));
      c.lineTo(...place(line[1]));
    }
    c.stroke();
  }

  const strongest = Math.max(0, ...data.forces.flatMap((force) => force.F_x.map((x, f) => Math.hypot(x, force.F_y[f]))));

  function drawForce(c, tip, F, longest) {
    const newtons = Math.hypot(...F), length = newtons / strongest * longest;
    if (!(length > longest / 120)) { return; }
    const u = F.map((v) => v / newtons), back = (d, aside) => [tip[0] - d * u[0] - aside * u[1],
                                                              tip[1] - d * u[1] + aside * u[0]];
    c.strokeStyle = c.fillStyle = curves[1];
    c.lineWidth = 2.5;
    path(c, [back(length, 0), tip, back(9, 4), tip, back(9, -4)]);
    c.stroke();
    c.font = "14px system-ui, sans-serif";
    c.textAlign = "center";
    c.fillText(Number(newtons.toPrecision(3)) + " N", ...back(length + 14 + 16 * Math.abs(u[0]), 0));
  }

  function drawMoment(c, p, value, radius) {
    if (!value) { return; }
    const turn = -Math.sign(value), from = Math.PI - turn, to = Math.PI + turn;
    c.strokeStyle = c.fillStyle = curves[1];
    c.lineWidth = 2.5;
    c.beginPath();
    c.arc(p[0], p[1], radius, from, to, turn < 0);
    const tip = (r, a) => [p[0] + r * radius * Math.cos(a), p[1] + r * radius * Math.sin(a)];
    c.moveTo(...tip(1.18, to - 0.3 * turn));
    c.lineTo(...tip(1, to));
    c.lineTo(...tip(0.84, to - 0.3 * turn));
    c.stroke();
    c.font = "14px system-ui, sans-serif";
    c.textAlign = "right";
    c.fillText(Number(value.toPrecision(3)) + " N m", p[0] - 1.2 * radius, p[1] + 5);
  }

  function drawGravity(c, width, down, ink) {
    c.strokeStyle = c.fillStyle = ink;
    c.lineWidth = 1.6;
    const [x, top, end] = [width - 34, 34 - 22 * down, 34 + 22 * down];
    path(c, [[x, top], [x, end], [x - 5, end - 9 * down], [x, end], [x + 5, end - 9 * down]]);
    c.stroke();
    c.font = "italic 15px system-ui, sans-serif";
    c.textAlign = "left";
    c.fillText("g", x + 9, 39);
  }

  function nameCurves(c, strip, right, left, y) {  // from the right, as many as there is room for
    if (strip.values.length < 2) { return; }
    for (let k = strip.names.length - 1, x = right; k >= 0; k--) {
      const width = c.measureText(strip.names[k]).width;
      if (x - width < left) {
        c.fillStyle = colour("--soft");
        c.fillText("…", x, y);
        return;
      }
      c.fillStyle = curves[k % curves.length];
      c.fillText(strip.names[k], x, y);
      x -= width + 8;
    }
  }

  function drawStrips() {
    const [c, width, height] = prepared(strips);
    const left = 52, right = width - 10, each = height / Math.max(data.strips.length, 1);
    const [ink, soft, line] = ["--ink", "--soft", "--line"].map(colour);
    const span = data.time[frames - 1] - data.time[0] || 1;
    const x = (f) => left + (data.time[f] - data.time[0]) / span * (right - left);
    data.strips.forEach((strip, s) => {
      const top = s * each + 22, bottom = (s + 1) * each - 8;
      const [low, high] = strip.range;
      const y = (v) => bottom - (v - low) / (high - low) * (bottom - top);
      c.font = "13px system-ui, sans-serif";
      c.fillStyle = ink;
      c.textAlign = "left";
      c.fillText(strip.label, left, top - 6);
      c.strokeStyle = line;
      c.lineWidth = 1;
      c.strokeRect(left, top, right - left, bottom - top);
      c.textAlign = "right";
      c.fillStyle = soft;
      [low, high].forEach((v) => c.fillText(Number(v.toPrecision(3)), left - 5, v === low ? bottom : top + 10));
      nameCurves(c, strip, right, left + c.measureText(strip.label).width + 10, top - 6);
      strip.values.forEach((values, k) => {
        const points = values.map((v, f) => [x(f), y(v)]);
        c.lineWidth = 1.5;
        c.strokeStyle = line;
        path(c, points);
        c.stroke();
        c.strokeStyle = c.fillStyle = curves[k % curves.length];
        path(c, points.slice(0, frame + 1));
        c.stroke();
        c.beginPath();
        c.arc(...points[frame], 4, 0, 2 * Math.PI);
        c.fill();
      });
    });
  }

  function draw() {
    drawScene();
    drawStrips();
    time.value = frame;
    const now = data.time[frame].toFixed(data.decimals) + " s";
    time.setAttribute("aria-valuetext", now);
    byId("state").textContent = "t = " + now + data.strips.map((strip) => strip.values.map((values, k) =>
      "; " + (strip.values.length > 1 ? strip.names[k] + " (" + strip.label + ")" : strip.label) + ": " +
      Number(values[frame].toPrecision(4))).join("")).join("");
  }

  // The slider's square: fine near 0, and twice what the film has, or more, where that shows little.
  const factorOf = (v) => Number((data.largest_zoom * (v / 1000) ** 2).toPrecision(3));

  function setZoom(value) {
    factor = value;
    byId("factor").textContent = "× " + Number(factor.toPrecision(3));
    zoom.setAttribute("aria-valuetext", "times " + Number(factor.toPrecision(3)));
    fit();
    draw();
  }

  function step(to) {
    frame = Math.min(Math.max(to, 0), frames - 1);
    started = performance.now() - (data.time[frame] - data.time[0]) / data.speed * 1000;
    draw();
  }

  function setPlaying(on) {
    playing = on && frames > 1;
    play.textContent = playing ? "Pause" : "Play";
    if (playing) {
      step(frame === frames - 1 ? 0 : frame);
      requestAnimationFrame(tick);
    }
  }

  function tick(now) {
    if (!playing) { return; }
    const t = data.time[0] + (now - started) / 1000 * data.speed;
    let next = frame;
    while (next + 1 < frames && data.time[next + 1] <= t) { next++; }
    if (next !== frame) { frame = next; draw(); }
    if (frame === frames - 1) { setPlaying(false); } else { requestAnimationFrame(tick); }
  }

  play.addEventListener("click", () => setPlaying(!playing));
  time.max = frames - 1;
  time.addEventListener("input", () => { setPlaying(false); step(Number(time.value)); });
  zoom.disabled = !(data.deformation_unit > 0);
  zoom.value = data.largest_zoom > 0 ? 1000 * Math.sqrt(data.zoom / data.largest_zoom) : 0;
  zoom.addEventListener("input", () => setZoom(factorOf(Number(zoom.value))));
  scene.addEventListener("keydown", (event) => {
    const moves = { ArrowLeft: -1, ArrowRight: 1, Home: -frames, End: frames };
    if (event.key === " ") { setPlaying(!playing); }
    else if (event.key in moves) { setPlaying(false); step(frame + moves[event.key]); }
    else { return; }
    event.preventDefault();
  });
  window.addEventListener("resize", draw);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  if (data.stress) {
    byId("scale").hidden = false;
    byId("low").textContent = Number(data.stress.range[0].toPrecision(3));
    byId("high").textContent = Number(data.stress.range[1].toPrecision(3)) + " " + data.stress.unit +
        ", largest bending stress";
    byId("bar").style.background = "linear-gradient(to right, " + viridis.join(", ") + ")";
  }
  setZoom(data.zoom);
  document.documentElement.dataset.drawn = frames;
}());

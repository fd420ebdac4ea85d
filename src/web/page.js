// SPDX-License-Identifier: BSD-3-Clause
// The page: fields become a scene, the worker runs the command on it, and the command's own JSON and picture are shown.
"use strict";
(() => {
const $ = (id) => document.getElementById(id);
const optionIds = ["units", "spacing", "dx", "dy", "missing"];

let surface = null;   // { name, bytes, kind }, kind as fstiff measure says: profile or map; measured: its JSON
let edited = false;   // the scene's text is the reader's own
let made = {};        // files that can be taken along
let worker = null, waiting = null, turns = 0;

// The program: unpacked and compiled once, while the reader looks for a file.
const compiled = (async () => {
    const packed = Uint8Array.from(atob(fstiff_engine.wasm), (letter) => letter.charCodeAt(0));
    fstiff_engine.wasm = "";
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return WebAssembly.compile(await new Response(stream).arrayBuffer());
})();
const script = URL.createObjectURL(new Blob([fstiff_engine.script], { type: "text/javascript" }));

async function startWorker() {
    const module = await compiled;
    if (worker) return;
    const started = worker = new Worker(script);
    worker.onmessage = ({ data }) => {
        if (started !== worker) return;
        if ("progress" in data) showProgress(data.progress);
        else finish(data);
    };
    worker.onerror = (error) => finish({ status: 1, errors: ["fstiff: " + error.message], files: {} });
    worker.postMessage({ module });
}

function finish(result) {
    const done = waiting;
    waiting = null;
    if (done) done(result);
}

/// Runs `fstiff words...` in a folder that holds files. An answer with status 4 is one that its warnings speak against.
async function run(words, files) {
    const turn = turns;
    await startWorker();
    if (turn !== turns) throw new Error("Stopped.");  // by a later one, while the program was unpacked
    const result = await new Promise((resolve) => {
        waiting = resolve;
        worker.postMessage({ words, files });
    });
    if (result.stopped) throw new Error("Stopped.");
    if (result.status !== 0 && result.status !== 4) {
        const sentence = result.errors.filter((line) => !line.startsWith("fstiff: warning:")).join(" ");
        throw new Error(sentence.replace(/^fstiff: /, "") || "The computation ended without an answer.");
    }
    return result.files;
}

function stop() {
    if (!waiting) return;
    worker.terminate();
    worker = null;
    finish({ stopped: true });
    startWorker();
}

function showProgress(text) {
    const share = /\] (\d+) %/.exec(text);
    if (share) $("bar").value = share[1] / 100;
    $("left").textContent = text.replace(/ \[.*\]/, ":");
}

/// One computation at a time, the latest; whatever goes wrong is one sentence.
async function working(title, steps) {
    const turn = ++turns;
    if (waiting) stop();
    $("problem").hidden = true;
    $("said").textContent = title + " …";
    $("left").textContent = "";
    $("bar").removeAttribute("value");
    $("working").hidden = false;
    try {
        await steps();
    } catch (error) {
        if (turn !== turns) return;
        $("said").textContent = "";
        $("problem").textContent = error.message;
        $("problem").hidden = false;
        if (/units|--dx|spacing|--missing|unit /.test(error.message)) $("reading").open = true;
    }
    if (turn === turns) $("working").hidden = true;
}

const text = (value) => JSON.stringify(value);  // a text of JSON is one of TOML
const number = (value) => (/^[-+.\deE]+$/.test(value.trim()) ? value.trim() : text(value.trim()));

function bodyText(id) {
    const name = $(id).value, hardness = id === "upper" ? $("hardness").value.trim() : "";
    const keys = name === "other" ? [`youngs_modulus = ${text($("modulus").value.trim() + " GPa")}`, `poisson_ratio = ${number($("ratio").value)}`]
        : name === "rigid" ? [`youngs_modulus = "1e9 GPa"`, "poisson_ratio = 0"] : [`name = ${text(name)}`];
    if (hardness) keys.push(`hardness = ${text(hardness + " GPa")}`);
    return keys.length === 1 ? text(name) : `{ ${keys.join(", ")} }`;
}

const measuredName = () => surface.name + ".measured.json";
const byName = () => surface && surface.measured && surface.kind === "map";

/// The scene of the fields: of a map by its measured parameters, which is quick, or with \p points of boundary elements.
function sceneText(points) {
    const lines = [...(surface ? [`name = ${text(surface.name)}`, ""] : []), "[surface]"];
    if (!surface) {
        lines.push('rms_height   = "0.8 um"', 'peak_radius  = "40 um"', 'peak_density = "500 /mm^2"');
    } else {
        lines.push(`from = ${text(byName() && !points ? measuredName() : surface.name)}`);
        if (surface.kind && !(byName() && !points))
            for (const [key, value] of readingOptions()) lines.push(`${key} = ${text(value)}`);
    }
    lines.push("", "[material]", `upper = ${bodyText("upper")}`);
    if ($("lower").value !== "same") lines.push(`lower = ${bodyText("lower")}`);
    const pressures = $("pressures").value.split(/[\s;]+|,(?!\d)/).filter(Boolean);  // "1,5" is refused as one
    lines.push("", "[contact]", `pressures = [${pressures.map((one) => text(one + " MPa")).join(", ")}]`);
    if (points) lines.push(`boundary_elements.points = ${points}`);
    return lines.join("\n") + "\n";
}

const readingOptions = () => optionIds.map((id) => [id, $(id).value.trim()]).filter(([, value]) => value);

function showScene() {
    for (const one of document.querySelectorAll(".other")) one.hidden = $("upper").value !== "other";
    if (!edited) $("scene").value = sceneText(0);
}

function sceneFiles(scene) {
    const files = { "scene.toml": new TextEncoder().encode(scene) };
    if (surface) files[surface.name] = surface.bytes;
    if (surface && surface.measured) files[measuredName()] = surface.measured;
    return files;
}

/// Reads the surface that was chosen; a measurement is read already.
async function measure() {
    if (surface.measured || /\.json$/i.test(surface.name)) return;
    const words = ["measure", surface.name, "--format", "json", "-o", measuredName()];
    for (const [key, value] of readingOptions()) words.push(`--${key}=${value}`);
    const files = await run(words, { [surface.name]: surface.bytes });
    surface.measured = files[measuredName()];
    surface.kind = JSON.parse(new TextDecoder().decode(surface.measured)).source.kind;
    showScene();
}

async function compute(scene, begun) {
    const words = ["run", "scene.toml", "--format", "json", "-o", "answer.json", "--plot", "picture.svg"];
    const files = await run(words, sceneFiles(scene));
    made = { "scene.toml": new TextEncoder().encode(scene), ...files };
    if (surface && surface.measured) made[measuredName()] = surface.measured;
    show(JSON.parse(new TextDecoder().decode(files["answer.json"])), begun);
}

/// Texts of the fields, from the file to the answer.
async function computeFields(points) {
    const begun = performance.now();
    if (!surface) throw new Error("No surface is chosen: drop a file, use the example, or compute the scene below.");
    await measure();
    await compute(sceneText(points), begun);
}

async function computeScene() {
    if (surface) await measure();
    await compute($("scene").value, performance.now());
}

/// A file that was dropped or chosen. A scene may name the surface that was chosen before it.
async function choose(file, buffer) {
    const name = file.replace(/^\.+|[\/\\\0]/g, "") || "surface", bytes = new Uint8Array(buffer);
    await working("Reading " + name, async () => {
        $("answer").hidden = true;
        edited = /\.toml$/i.test(name);
        if (edited) {
            $("scene").value = new TextDecoder().decode(bytes);
            $("scene-part").open = true;
            return computeScene();
        }
        surface = { name, bytes, kind: null };
        $("chosen").textContent = "Chosen: " + name;
        return computeFields(0);
    });
}

const rounded = (value, digits) => Number(value.toPrecision(digits)).toString();

function cells(row, tag, values) {
    for (const value of values) {
        const cell = document.createElement(tag);
        cell.textContent = value;
        if (tag === "th") cell.scope = "col";
        row.append(cell);
    }
}

function showTable(answer) {
    const loads = answer.some((one) => "loading_stiffness_Pa_per_m" in one);
    const table = $("table");
    table.replaceChildren();
    cells(table.createTHead().insertRow(), "th",
        ["pressure [MPa]", "K/A₀ [MPa/µm]", "90 % band", ...(loads ? ["loading K/A₀"] : []), "law", "band due to"]);
    const body = table.createTBody();
    for (const one of answer) {
        const shown = (key, digits = 3) => (key in one ? rounded(one[key] / 1e12, digits) : "-");
        const close = one.stiffness_p95_Pa_per_m - one.stiffness_p05_Pa_per_m < 0.2 * one.stiffness_Pa_per_m;
        const [low, high] = ["stiffness_p05_Pa_per_m", "stiffness_p95_Pa_per_m"].map((key) => shown(key, close ? 3 : 2));
        cells(body.insertRow(), "td", [rounded(one.pressure_Pa / 1e6, 3), shown("stiffness_Pa_per_m"), `${low}–${high}`,
            ...(loads ? [shown("loading_stiffness_Pa_per_m")] : []), one.law.replaceAll("_", " "), one.band_due_to]);
    }
}

function showDownloads() {
    const list = $("downloads");
    for (const link of list.querySelectorAll("a")) URL.revokeObjectURL(link.href);
    list.replaceChildren();
    for (const [name, bytes] of Object.entries(made)) {
        const link = document.createElement("a");
        link.href = URL.createObjectURL(new Blob([bytes], { type: "application/octet-stream" }));
        link.download = link.textContent = name.split("/").pop();
        list.appendChild(document.createElement("li")).append(link);
    }
}

function show(document_, begun) {
    const answer = document_.answer || [];
    const sentence = (words) => words.charAt(0).toUpperCase() + words.slice(1) + (/[.!?]$/.test(words) ? "" : ".");
    $("version").textContent = document_.fstiff_version;
    const source = document_.surface && document_.surface.source;
    $("of").textContent = source ? `${source.file}, a ${source.kind}.` : "Of the numbers of the scene.";
    showTable(answer);
    const words = $("words");
    words.replaceChildren();
    const assumed = (document_.assumptions || []).length ? ["Assumed: " + document_.assumptions.join("; ")] : [];
    const next = document_.measure_next ? [document_.measure_next] : [];
    for (const one of [...(document_.explanation || []), document_.outside_band || "", ...assumed, ...next,
        ...document_.warnings.map((warning) => "Warning: " + warning)].filter(Boolean)) {
        const paragraph = document.createElement("p");
        paragraph.textContent = sentence(one);
        paragraph.className = one.startsWith("Warning: ") ? "warning" : "";
        words.append(paragraph);
    }
    URL.revokeObjectURL($("picture").src);
    $("picture").src = URL.createObjectURL(new Blob([made["picture.svg"]], { type: "image/svg+xml" }));
    $("picture").alt = `K/A₀ against pressure. ${(document_.explanation || [""])[0]}`;
    $("elements").hidden = !byName();
    showDownloads();
    $("answer").hidden = false;
    $("answer").dataset.milliseconds = Math.round(performance.now() - begun);
    const middle = answer[Math.floor(answer.length / 2)];
    $("said").textContent = middle ? `Done. At ${rounded(middle.pressure_Pa / 1e6, 3)} MPa K/A₀ is ${rounded(middle.stiffness_Pa_per_m / 1e12, 3)} MPa/µm.` : "Done.";
}

async function makeExample() {
    const words = ["generate", "map", "--points", "256", "--spacing", "1 um", "--hurst", "0.8", "--rms", "1 um", "--longest",
        "64 um", "--format", "sdf", "-o", "example.sdf"];
    let bytes;
    await working("Making a map", async () => { bytes = (await run(words, {}))["example.sdf"]; });
    if (bytes) await choose("example.sdf", bytes);
}

const option = (value, words) => new Option(words || value.replaceAll("_", " "), value);
for (const name of fstiff_engine.materials) $("upper").add(option(name));
$("upper").add(option("other", "another: E and Poisson's ratio"));
$("lower").add(option("same", "as the first"));
$("lower").add(option("rigid"));
for (const name of fstiff_engine.materials) $("lower").add(option(name));

$("inputs").addEventListener("input", () => {
    if (!edited) showScene();
});
for (const id of optionIds) $(id).addEventListener("input", () => { if (surface) surface.measured = null; });
$("inputs").addEventListener("submit", (event) => {
    event.preventDefault();
    edited = false;
    showScene();
    working("Computing", () => computeFields(0));
});
$("file").addEventListener("change", async () => {
    const [file] = $("file").files;
    if (file) choose(file.name, await file.arrayBuffer());
});
addEventListener("dragover", (event) => { event.preventDefault(); $("drop").classList.add("over"); });
addEventListener("dragleave", () => $("drop").classList.remove("over"));
addEventListener("drop", async (event) => {
    event.preventDefault();
    $("drop").classList.remove("over");
    const [file] = event.dataTransfer.files;
    if (file) choose(file.name, await file.arrayBuffer());
});
$("example").addEventListener("click", makeExample);
$("stop").addEventListener("click", stop);
$("solve").addEventListener("click", () => working("Boundary elements", () => computeFields(Number($("points").value))));
$("print").addEventListener("click", () => print());
$("scene").addEventListener("input", () => { edited = true; });
$("run-scene").addEventListener("click", () => working("Computing the scene", computeScene));
showScene();
startWorker().catch((error) => {
    $("problem").textContent = "This browser cannot run the page: " + error.message;
    $("problem").hidden = false;
});
})();

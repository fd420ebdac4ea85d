// SPDX-License-Identifier: BSD-3-Clause
// Runs one command at a time: {module} once, then {words, files} each answered by {status, errors, files}; while a command
// runs, {progress} is what its progress bar shows. A fresh instance each time: a command may leave anything behind.
"use strict";
let compiled;

/// Gathers bytes of standard error into lines; a bar is a line that the next carriage return replaces.
function errorLines(onBar) {
    const bytes = [], lines = [], decoder = new TextDecoder();
    const end = (isBar) => {
        const text = decoder.decode(new Uint8Array(bytes)).replace(/\x1b\[K/g, "");
        bytes.length = 0;
        if (isBar) onBar(text);
        else if (text) lines.push(text);
    };
    return {
        lines,
        put: (byte) => {
            if (byte === 10) end(false);
            else if (byte === 13) bytes.length = 0;
            else if (bytes.push(byte) > 2 && byte === 75 && bytes.at(-2) === 91) end(true);  // ESC [ K ends a bar
        }
    };
}

async function execute({ words, files }) {
    const errors = errorLines((text) => text && self.postMessage({ progress: text }));
    const program = await fstiff({
        stdin: () => null, stdout: () => {}, stderr: errors.put,
        instantiateWasm: (imports, done) => {
            WebAssembly.instantiate(compiled, imports).then((instance) => done(instance, compiled));
            return {};
        }
    });
    const { FS } = program;
    FS.streams[2].tty = { ops: {} };  // a terminal has a progress bar
    FS.mkdir("/surface");
    FS.chdir("/surface");
    for (const [name, bytes] of Object.entries(files)) FS.writeFile(name, bytes);
    const status = program.callMain(words);
    const made = {};
    const gather = (folder) => {
        for (const name of FS.readdir(folder).filter((name) => !name.startsWith("."))) {
            const path = folder + "/" + name;
            if (FS.isDir(FS.stat(path).mode)) gather(path);
            else if (!(name in files)) made[name] = FS.readFile(path);
        }
    };
    gather(".");
    return { status, errors: errors.lines, files: made };
}

self.onmessage = async ({ data }) => {
    if (data.module) {
        compiled = data.module;
        return;
    }
    try {
        self.postMessage(await execute(data));
    } catch (error) {
        const why = /memory|OOM/i.test(String(error)) ? "out of memory" : "internal error: " + error;
        self.postMessage({ status: 1, errors: ["fstiff: " + why], files: {} });
    }
};

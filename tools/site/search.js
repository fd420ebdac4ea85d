// SPDX-License-Identifier: BSD-3-Clause
// Lists the titles of titles.js that have every word of the field.
"use strict";
{
    const root = document.currentScript.dataset.root;
    const field = document.getElementById("search");
    const list = document.getElementById("found");
    const item = ([url, title, page]) => {
        const link = document.createElement("a");
        link.href = root + url;
        link.textContent = title === page ? title : `${page}: ${title}`;
        const line = document.createElement("li");
        line.append(link);
        return line;
    };
    field.addEventListener("input", () => {
        const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
        const has = ([, title, page]) => words.every((word) => `${page} ${title}`.toLowerCase().includes(word));
        list.replaceChildren(...(words.length ? titles.filter(has).slice(0, 30) : []).map(item));
    });
}

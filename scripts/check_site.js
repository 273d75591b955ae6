// Pages of the site in frames of a phone's width, four at a time; see check_site.sh.
"use strict";

function say(text) {
    const said = document.createElement("pre");
    said.textContent = text;
    document.body.append(said);
}

// What of a loaded page its reader cannot see or has to scroll for.
async function complaints(window) {
    const found = [], page = window.document.documentElement;
    await window.document.fonts.ready;
    if (page.scrollWidth > window.innerWidth) {
        const wide = [...window.document.querySelectorAll(".rst-content *")].filter(element => {
            const {right} = element.getBoundingClientRect();
            return right > window.innerWidth && right <= page.scrollWidth + 1;
        });
        const at = wide.length ? wide[wide.length - 1].outerHTML.slice(0, 80) : "?";
        found.push(`is ${page.scrollWidth} px wide at ${at}`);
    }
    for (const image of window.document.images) {
        if (image.naturalWidth === 0) found.push(`picture ${image.getAttribute("src")} is missing`);
    }
    // A blank line within a table leaves rows without a head, shown as text.
    for (const {textContent} of window.document.querySelectorAll(".rst-content p")) {
        if (/^\|.*\|$/m.test(textContent)) found.push(`has a row outside of its table: ${textContent.slice(0, 60)}`);
    }
    if (window.document.querySelector(".katex-error")) found.push("has a formula with an error");
    if (window.document.querySelector(".katex") && !window.document.fonts.check("16px KaTeX_Main"))
        found.push("has formulas without their font");
    for (const {name} of window.performance.getEntriesByType("resource")) {
        if (!/^(file|data|blob):/.test(name)) found.push(`asks for ${name}`);
    }
    return found;
}

async function reader(failures) {
    const frame = document.createElement("iframe");
    frame.style = "width: 400px; height: 800px; border: 0";
    document.body.append(frame);
    while (pages.length) {
        const page = pages.shift();
        await new Promise(resolve => {
            frame.onload = resolve;
            frame.src = site + page;
        });
        for (const text of await complaints(frame.contentWindow)) failures.push(`FAILED: ${page}: ${text}`);
    }
    frame.remove();
}

addEventListener("load", async () => {
    const n = pages.length, failures = [];
    await Promise.all([1, 2, 3, 4].map(() => reader(failures)));
    failures.forEach(say);
    say(`${n} pages, ${failures.length} failures`);
});

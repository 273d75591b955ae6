// Makes HTML of formulas: a line of JSON in, {"tex", "display"}, a line of JSON out, {"html"} or {"error"}.
// usage: node katex.js KATEX.js
"use strict";

const katex = require(process.argv[2]);

require("readline").createInterface({input: process.stdin}).on("line", line => {
    const {tex, display} = JSON.parse(line);
    const answer = {};
    try {
        answer.html = katex.renderToString(tex, {displayMode: display, throwOnError: true, strict: "error"});
    } catch (error) {
        answer.error = error.message;
    }
    process.stdout.write(JSON.stringify(answer) + "\n");
});

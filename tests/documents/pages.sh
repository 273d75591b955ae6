#!/usr/bin/env bash
# Pages of the documents have a picture or a table, and formulas that are rendered; what the site is made of - formulas looked
# for, notebooks, references of Python and C++ - by small examples.
# usage: pages.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
pages=$source_dir/tests/documents/pages.py

"$python" "$pages" "$source_dir" "$source_dir/tests/documents/pages_without_picture.txt" || complain "pages of the documents"

# complains EXPECTED: a page of this text, from the standard input, is complained about, once; "" not at all.
mkdir -p tree/docs
printf '# Tree\n\n| a |\n|---|\n' >tree/README.md
complains() {
    cat >tree/docs/page.md
    "$python" "$pages" tree "${2:-/dev/null}" >told && [ -n "$1" ] && complain "passes, without: $1"
    [ "$(grep -c FAILED told)" -eq $((${#1} > 0)) ] || complain "expected <$1>, got $(cat told)"
    grep -qF "docs/page.md$1" told || [ -z "$1" ] || complain "expected $1, got $(cat told)"
}
printf '# Page\n\nText.\n' | complains ": neither picture nor table"
printf '# Page\n\n| a | b |\n|---|---|\n| 1 | 2 |\n' | complains ""
printf '# Page\n\n```text\n| a |\n|---|\n![a](b.png)\n```\n' | complains ": neither picture nor table"
printf '# Page\n\n| a |\n|---|\n\nThen\n\n    E = m c^2\n' | complains ":8: a block set off by blanks"
printf '# Page\n\n| a |\n|---|\n\n```math\n    E = m c^2\n```\n\n- item\n\n      more of it\n' | complains ""
printf '# Page\n\n![a](none.png)\n' | complains ": no picture none.png"
echo 'docs/page.md: short' >list
printf '# Page\n\nText.\n' | complains "" list
printf '# Page\n\n| a |\n|---|\n' | complains ": has a picture or table" list
mkdir -p tree/docs/images/gallery
head -c 60001 /dev/zero >tree/docs/images/gallery/large.png
printf '# Page\n\n![a](images/gallery/large.png)\n' | complains ": images/gallery/large.png has 60001 bytes"

# Formulas of a site: one that is rendered passes with its TeX in an annotation, code is not looked at.
mkdir site
formula='<span class="katex"><annotation encoding="application/x-tex">\frac12 $x$</annotation>1/2</span>'
site() {
    printf '<html><body><p>%s</p><p>%s</p></body></html>' "$formula" "$1" >site/page.html
    "$python" "$source_dir/scripts/check_site.py" site >told
}
# shellcheck disable=SC2016  # dollars are meant
site 'a path of $HOME, or <code>echo "$a$"</code>, <img src="a.png">' || complain "$(cat told)"
for bad in 'so $x = 1$ holds' 'a \frac{1}{2}' '\sum_i' '```math' '<code>```math</code>' '<span class="katex-error">x</span>' \
    '<div class="math">x</div>' '<script src="https://host/x.js"></script>' '<img src="//host/x.png">'; do
    ! site "$bad" || complain "passes: $bad"
done
formula=''
! site 'a page' || complain "a site without formulas passes"

# A notebook: text, code, a table, a picture, what is printed; what needs scripts is shown as text.
mkdir -p notebooks page
cat >notebooks/small.ipynb <<'END'
{"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": [
 {"cell_type": "markdown", "metadata": {}, "source": ["# Small\n", "\n", "Text with $x^2$."]},
 {"cell_type": "code", "execution_count": 1, "metadata": {}, "source": "1 + 1", "outputs": [
  {"output_type": "stream", "name": "stdout", "text": ["said ```\n"]},
  {"output_type": "execute_result", "metadata": {}, "execution_count": 1, "data": {"text/html": "<table><tr><td>2</td></tr></table>", "text/plain": "2"}},
  {"output_type": "display_data", "metadata": {}, "data": {"image/png": "iVBORw0KGgo=", "text/plain": "figure"}},
  {"output_type": "display_data", "metadata": {}, "data": {"text/html": "<script>1</script>", "text/plain": "scripted"}}]},
 {"cell_type": "code", "execution_count": null, "metadata": {}, "source": "", "outputs": []}]}
END
"$python" "$source_dir/scripts/site/notebooks.py" notebooks page >told || complain "$(cat told)"
cat >expected <<'END'
# Small

Text with $x^2$.

```python
1 + 1
```

````text
said ```
````

```{raw} html
<div class="notebook-output"><table><tr><td>2</td></tr></table></div>
```

![Output of the cell above](small_1.png)

```text
scripted
```
END
diff expected page/small.md || complain "another page of the notebook"
[ "$(head -c 4 page/small_1.png | tail -c 3)" = PNG ] || complain "no picture of the notebook"

# The references: what is declared in a header for others, and nothing private; each name that the module exports.
mkdir -p project/room
cat >project/room/CMakeLists.txt <<'END'
tricontact_library(room DEPENDS tricontact_contact)
END
echo '| core | `room/` | what it holds | nothing |' >project/CONTRIBUTING.md
cat >project/room/a.h <<'END'
#pragma once
#include <vector>
namespace tricontact::room {
/// Sum [m] of x_i.
inline double sum(const std::vector<double>& x) {
    double s = 0;  // {
    return s;
}
/// A thing.
class Thing final : public Base {
  public:
    explicit Thing(int n) : n_(n), list_{n} {}
    /// How many.
    int n() const { return n_; }

  private:
    int hidden() const;
    int n_;
};
template <class T>
T twice(T x);  ///< 2 x
}  // namespace tricontact::room
END
"$python" "$source_dir/scripts/site/cpp_reference.py" project cpp >told || complain "$(cat told)"
for words in '### sum' 'Sum \[m\] of x\_i.' 'inline double sum(const std::vector<double>& x);' 'explicit Thing(int n);' \
    '/// How many.' 'int n() const;' '### twice' 'T twice(T x);  ///< 2 x'; do
    grep -qF -- "$words" cpp/room.md || complain "not in the C++ reference: $words"
done
! grep -qE 'hidden|n_|return' cpp/room.md || complain "private parts are in the C++ reference"
grep -q '^| \[room\](room.md) | 1 | 3 | what it holds |$' cpp/index.md || complain "$(cat cpp/index.md)"
"$python" "$source_dir/scripts/site/python_reference.py" "$source_dir" api >told || complain "$(cat told)"
for words in '.. py:function:: run(' '.. py:class:: Case' '.. py:exception:: InputError' '.. py:module:: tricontact.theory' \
    '.. py:function:: static_shift_ratio('; do
    grep -qF -- "$words" api/python-api.rst || complain "not in the Python reference: $words"
done
finish

#include "page.hpp"

namespace velum_gallery {

const char* const style_sheet = R"css(
:root { color-scheme: light dark; --ground: #f6f4ef; --ink: #23252b; --soft: #6b6f7a; --card: #ffffff;
        --line: #dedbd2; --mark: #9a4f1e; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #17181c; --ink: #e6e4de; --soft: #9b9fa9; --card: #22242a; --line: #34373f; --mark: #e0a070; }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
header, main { max-width: 1500px; margin: 0 auto; padding: 1rem 1.5rem; }
h1 { margin: .5rem 0 0; font-weight: 600; }
h2 { margin: 0; font-weight: 600; }
p { margin: .25rem 0 .5rem; max-width: 70ch; }
a { color: var(--mark); }
nav { display: flex; flex-wrap: wrap; gap: .2rem .9rem; padding: .5rem 0; }
section { padding: 1.2rem 0; border-top: 1px solid var(--line); scroll-margin-top: .5rem; }
.family { font-size: .8rem; color: var(--mark); border: 1px solid var(--line); border-radius: 1em; padding: .1em .7em; }
.fine { font-size: .85rem; color: var(--soft); }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(240px, 1fr)); gap: 1rem; align-items: start; }
figure { margin: 0; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: .5rem; min-width: 0; }
img { display: block; width: 100%; height: auto; }
figcaption { padding: .2rem .2rem 0; font-size: .9rem; }
details { padding: 0 .2rem; font-size: .8rem; color: var(--soft); overflow-x: auto; }
summary { cursor: pointer; }
ol { padding-left: 1.4rem; }
li { margin: .5rem 0; }
li b { color: var(--ink); font-family: ui-monospace, monospace; }
table { border-collapse: collapse; margin: .2rem 0; border: solid var(--soft); border-width: 0 1px; border-radius: 5px; }
td { padding: 0 .5em; text-align: right; font: .75rem ui-monospace, monospace; color: var(--ink); }
)css";

}  // namespace velum_gallery

//! The rules of a page: light, dark, phone, paper.

pub(super) const STYLE: &str = "\
:root{--ink:#111;--soft:#5b6470;--pap:#fff;--line:#d4d8de;--acc:#0072b2}
@media (prefers-color-scheme:dark){:root{--ink:#ececec;--soft:#a4adb8;--pap:#16181c;--line:#3a3f47;--acc:#56b4e9}}
body{font-family:\"Times New Roman\",Tinos,\"Liberation Serif\",serif;color:var(--ink);background:var(--pap);max-width:56rem;margin:0 auto;padding:1.5rem 1.2rem 4rem;line-height:1.5;font-size:17px}
h1{font-size:1.7rem;line-height:1.2;margin:.2em 0 .4em}
h2{font-size:1.3rem;margin:2em 0 .5em;border-bottom:1px solid var(--line);padding-bottom:.2em}
h3{font-size:1.08rem;margin:1.4em 0 .3em}
p{margin:.5em 0}.soft{color:var(--soft)}
table{border-collapse:collapse;margin:.8em 0;font-variant-numeric:tabular-nums}
th,td{border:1px solid var(--line);padding:.25em .7em;text-align:left}
th{font-weight:600}td.n{text-align:right}
table.vec{border:0;white-space:nowrap}.tab{overflow-x:auto}
table.vec th,table.vec td{border:0;padding:.15em .35em;text-align:center}
table.vec th{color:var(--soft);font-weight:400;text-align:right}
.eq{margin:.3em 0;padding:.25em 0 .35em 2em;overflow-x:auto;overflow-y:hidden}
mtd{text-align:left;padding:.15em .1em}mtd.l{text-align:right}
math{font-size:1.02em;font-family:\"STIX Two Math\",\"Latin Modern Math\",\"Cambria Math\",math}
figure{margin:1.2em 0;max-width:100%;overflow-x:auto}
figure svg{max-width:100%;height:auto;display:block}
figcaption{color:var(--soft);font-size:.93em;margin-top:.4em}
.two{display:flex;flex-wrap:wrap;gap:.5rem 2.5rem;align-items:end}.two figure{margin:.8em 0}
nav ol{columns:2;padding-left:1.2em}a{color:var(--acc);text-decoration:none}
@media(max-width:34rem){.eq{padding-left:.4em}nav ol{columns:1}}
@media print{:root{--ink:#000;--soft:#444;--pap:#fff;--line:#aaa;--acc:#000}
h2,h3{break-after:avoid}figure,table,.eq{break-inside:avoid}.eq,.tab,figure{overflow:visible}
.long{break-inside:auto}.eq.long{margin:0;padding:0 0 0 2em}tr{break-inside:avoid}
table.vec{white-space:nowrap;font-size:.88em}h2{margin-top:1.2em}td,th{padding:.12em .6em}nav{display:none}.two{display:block;orphans:1;widows:1;word-spacing:2.5rem}.two figure{display:inline-block;vertical-align:bottom;word-spacing:normal}
.fit{font-size:calc(1em*var(--fit))}.free svg{max-height:118mm}@page{size:A4;margin:16mm 14mm}body{font-size:10.5pt;max-width:none;padding:0}}
";

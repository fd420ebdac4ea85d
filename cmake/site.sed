# SPDX-License-Identifier: BSD-3-Clause
# Pages of docs/ as Doxygen takes them: a link within a page, or to a file that is not in the site, stays as text; a link to a
# part of another page goes to that page; the list of the pages is the main page; Doxygen 1.9 takes no ** before a `.
s/\[([^]]*)\]\(#[^)]*\)/\1/g
s/\[([^]]*)\]\(\.\.\/(data|bench|README)[^)]*\)/\1/g
s/\]\(([a-z_-]*\.md)#[^)]*\)/](\1)/g
s/\]\(README\.md\)/](@ref index)/g
s/\*\*(`[^*]*)\*\*/<b>\1<\/b>/g

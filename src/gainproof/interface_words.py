"""Interface words of the pages of sources, in English and in Japanese (the sources' own language).

Only what the site itself says is translated: formulas, quotations, reasons and proofs stay as they
are.
"""

from __future__ import annotations

from collections.abc import Mapping

LANGUAGES: Mapping[str, str] = {"en": "English", "ja": "日本語"}

# key: (English, Japanese)
_WORDS: Mapping[str, tuple[str, str]] = {
    "derivations": ("Derivations", "導出"),
    "sources": ("Sources", "文献"),
    "kernels": ("Kernels", "カーネル"),
    "documents": ("Documentation", "解説"),
    "check": ("Check a formula", "数式の判定"),
    "bibliography": ("Bibliography", "参考文献"),
    "names": ("Index", "索引"),
    "search": ("Search", "検索"),
    "contents": ("Contents", "目次"),
    "skip": ("Skip to the content", "本文へ"),
    "appearance": ("Appearance", "表示"),
    "appearance-auto": ("as the system", "システムに従う"),
    "appearance-light": ("light", "明るい"),
    "appearance-dark": ("dark", "暗い"),
    "copy": ("Copy LaTeX", "LaTeXをコピー"),
    "copied": ("Copied", "コピーしました"),
    "this-page-in": ("This page in", "このページの言語"),
    "by": ("by", "著者"),
    "errata": ("Errata", "正誤表"),
    "no-errata": (
        "Every claim that can be decided stands as printed.",
        "判定できる主張は、すべて印刷どおりに成り立つ。",
    ),
    "cannot-stand": (
        "Statements that cannot stand as printed, or as they are read",
        "印刷どおり、または読んだとおりには成り立たない主張",
    ),
    "origin-printed": ("As printed", "印刷どおり"),
    "origin-words": ("In words", "文章による主張"),
    "origin-reconstructed": ("Reconstructed by us", "再構成した式"),
    "origin-ours": ("Ours, not in the source", "文献にはない補足"),
    "about": ("About it", "説明"),
    "read-as": ("Read as", "読み方"),
    "what-is-true": ("What is true", "正しくは"),
    "one-change": ("One change repairs all of these", "同じ一つの訂正ですべて正しくなる"),
    "symbols": ("Symbols", "記号"),
    "where-condition": ("Where", "条件"),
    "note": ("Note (ours)", "注(編者)"),
    "claims": ("Claims, in the order of the source", "主張(文献の順)"),
    "claim": ("claim", "主張"),
    "verdicts": ("Verdicts", "判定"),
    "place": ("place", "箇所"),
    "domain": ("domain", "定義域"),
    "method": ("method", "方法"),
    "reading": ("Read so that", "読み方"),
    "convention": ("Convention", "規約"),
    "undefined": ("Undefined symbol", "未定義の記号"),
    "why": ("Why", "理由"),
    "checked": ("checked", "検証"),
    "read-instead": ("Read instead", "正しくは"),
    "printed": ("Printed", "印刷"),
    "proof": ("Proof", "証明"),
    "witness": ("Witness", "反例"),
    "details": ("Details", "詳細"),
    "original": ("Original", "原文"),
    "verdict-proved": ("proved", "証明済み"),
    "verdict-refuted": ("refuted", "反証"),
    "verdict-conditional": ("conditional", "条件付き"),
    "verdict-undefined": ("undefined", "未定義"),
    "verdict-held": ("held", "数値のみ"),
    "verdict-undecided": ("undecided", "未決定"),
    "verdict-definition": ("definition", "定義"),
    "verdict-remark": ("remark", "注釈"),
    "means-proved": (
        "an exact argument on the whole stated domain",
        "述べられた定義域全体での厳密な論証",
    ),
    "means-refuted": (
        "an exact counterexample inside the stated domain, and no convention that saves the claim",
        "定義域内の厳密な反例があり、どの規約でも成り立たない",
    ),
    "means-conditional": (
        "true on a part of the domain, which is given, or under a convention that is named",
        "示された部分領域、または明記された規約の下でのみ成り立つ",
    ),
    "means-undefined": (
        "uses a symbol that the source never defines and that its claims do not fix",
        "文献が定義せず、他の主張からも定まらない記号を使う",
    ),
    "means-held": (
        "agreed at exact points, no proof",
        "厳密な点では一致したが、証明はない",
    ),
    "means-undecided": ("neither, and why", "いずれでもない(理由を示す)"),
    "means-definition": (
        "nothing to decide but dimensions",
        "次元のほかに判定することがない",
    ),
    "means-remark": (
        "a sentence without decidable content",
        "判定できる内容を持たない文",
    ),
}


def in_language(language: str) -> dict[str, str]:
    """The words of one language by key. Raises KeyError for a language that there is not."""
    place = list(LANGUAGES).index(language) if language in LANGUAGES else None
    if place is None:
        raise KeyError(language)
    return {key: both[place] for key, both in _WORDS.items()}

"""Ways into a syntax tree."""

from __future__ import annotations

from lark import Token, Tree

Branch = Tree[Token]


def children(tree: Branch) -> list[Branch]:
    """The subtrees among the children."""
    return [child for child in tree.children if isinstance(child, Tree)]


def tokens(tree: Branch, kind: str) -> list[Token]:
    """The tokens of one kind among the children."""
    return [child for child in tree.children if isinstance(child, Token) and child.type == kind]


def sole(tree: Branch) -> Branch:
    """The innermost tree of a sum of one term with a plus, a product of one factor."""
    while tree.data in ("sum", "product") and len(tree.children) == 1:
        (child,) = tree.children
        assert isinstance(child, Tree)
        tree = child
    return tree


def start(tree: Branch) -> int:
    """Where the tree begins in the text."""
    return int(tree.meta.start_pos)


def printed(tree: Branch, text: str) -> str:
    """The tree as printed, cut."""
    return text[tree.meta.start_pos : tree.meta.end_pos][:40]


def first_token(tree: Branch, kind: str) -> Token | None:
    """The first token of a kind anywhere in the tree."""
    waiting: list[Branch | Token] = [tree]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Tree):
            waiting += reversed(part.children)
        elif part.type == kind:
            return part
    return None

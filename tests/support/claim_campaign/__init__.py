"""Campaign over claim files: what is proved, broken and rewritten, and judged again; whether a
broken claim is false is decided by values that share nothing with the judge.
"""

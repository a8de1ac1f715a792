"""What derivations write, judged like claims: relations, statements of certificates, programs of
kernels. No command uses it; the tests of derivations and the campaigns that alter them do
(`tests/verify/judge/derivations/`, `tests/campaigns/mutation.py`).
"""

"""What derivations write, judged like claims: relations, statements of certificates, programs of
kernels. Tests of derivations and the campaigns that alter them ask it
(`tests/campaigns/mutation.py`).
"""

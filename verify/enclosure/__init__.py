"""Steady states of models in numbers, with proof: `steady` finds them and gives certificates that
`gainproof.verify.check_enclosure` decides, `structure` says exactly why there is none.
"""

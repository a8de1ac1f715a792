"""What the quantities of a setting are: steady states and growing memories, solved and established
here.
"""

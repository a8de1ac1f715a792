"""What the quantities of a setting are: steady states, growing and fading memories, solved and
established here.
"""

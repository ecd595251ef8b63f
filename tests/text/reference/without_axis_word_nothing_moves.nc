O1 (REF-1: G28 alone)
G90 G00 X5.
G28 (expect moves: none)
M30
(finally machine X5)

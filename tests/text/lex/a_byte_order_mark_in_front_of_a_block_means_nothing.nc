G00 X5. (expect moves: rapid X5)
M30
(finally machine X5)

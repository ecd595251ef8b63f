O1 (section 8: M30 is the last)
M30 G90 G00 X5. (expect moves: rapid X5)
(finally machine X5)

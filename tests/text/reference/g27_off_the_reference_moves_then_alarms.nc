O1 (G27 moves first: whether the point is the reference point shows when the tool is there)
G90 G00 Z5.
G27 X10. (expect alarm PS0092) (expect moves: rapid X10 Z5)
M30
(finally machine X10 Z5)

O1 (REF-1: only the named axis goes home)
G90 G00 X5. Z5.
G91 G28 Z0 (expect moves: rapid X5 Z0)
M30
(finally machine X5 Z0)

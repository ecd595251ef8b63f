O1 (REF-1: 3 further up, then home)
G90 G00 X5. Z5.
G91 G28 Z3. (expect moves: rapid X5 Z8; rapid X5 Z0)
M30

O1 (REF-3: G29 passes 5 on its way to 20)
G90 G00 X2.
G28 X5. (expect moves: rapid X5; rapid X0)
G29 X20. (expect moves: rapid X5; rapid X20)
M30

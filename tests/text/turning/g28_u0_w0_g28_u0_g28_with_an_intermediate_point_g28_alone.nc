(run with: --machine lathe2)
O1 (G28 U0 W0, G28 U0, G28 with an intermediate point, G28 alone)
G97S500M03
G00X60.Z5.
G28U0
G00X60.Z5.
G28W3.
G00X60.Z5.
G28X80.Z10.
G00X60.Z5.
G28
G28U0W0
M30
(finally moves: rapid X60 Z5; rapid X0 Z5; rapid X60 Z5; rapid X60 Z8; rapid X60 Z0; rapid X60 Z5; rapid X80 Z10; rapid X0 Z0; rapid X60 Z5; rapid X0 Z0)

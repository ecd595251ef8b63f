(run with: --machine lathe2)
O1 (Words)
G00X50.Z5.
G28U0.G28W0. (expect moves: rapid X0 Z0)
M30

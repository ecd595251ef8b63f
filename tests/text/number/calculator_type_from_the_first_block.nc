(run with: --param DPI=1)
O1 (DPI acts from the first block on)
X10 (expect moves: rapid X10)
M30

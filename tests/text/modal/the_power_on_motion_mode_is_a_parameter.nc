(run with: --param G01_default=1)
O1 (section 0.1: G01_default)
F100
X1. (expect moves: line X1 F100)
M30

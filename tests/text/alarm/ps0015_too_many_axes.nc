(run with: --machine mill5 --param simultaneous_axes=4)
O1 (PS0015: five axes at once where four are allowed)
G01 X1. Y1. Z1. A1. F100
G01 X2. Y2. Z2. A2. C2. (expect alarm PS0015)
M30

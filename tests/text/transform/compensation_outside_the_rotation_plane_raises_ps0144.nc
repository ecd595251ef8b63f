(run with: --set #13001=5)
O1 (TRF-3: compensation in another plane than that of the rotation)
G68 X0 Y0 R90.
G18
G41 D1 G01 X1. Z1. F10 (expect alarm PS0144)
M30

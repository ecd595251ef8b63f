(run with: --set #13001=5)
O1 (CRC-15: G40 first)
G41 D1 G01 X10. F100
Y50.
G45 X30. (expect alarm PS0042)
M30

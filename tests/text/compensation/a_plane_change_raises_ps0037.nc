(run with: --set #13001=5)
O1 (CRC-15: G40 first)
G41 D1 G01 X1. F100
Y5.
G18 (expect alarm PS0037 at G18)
M30

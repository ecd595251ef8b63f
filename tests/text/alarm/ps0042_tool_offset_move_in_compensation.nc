(run with: --set #13001=5)
O1 (PS0042: G46 under G41)
G41 D1 G01 X10. F100
X20.
G46 X30. (expect alarm PS0042)
M30

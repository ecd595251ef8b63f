(run with: --set #13001=5)
O1 (PS0037: G19 under G41)
G41 D1 G01 X10. F100
X20.
G19 (expect alarm PS0037 at G19)
M30

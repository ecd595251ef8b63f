(run with: --set #13001=5)
O1 (PS0035: G31 under G42)
G42 D1 G01 X10. F100
X20.
G31 X30. (expect alarm PS0035)
M30

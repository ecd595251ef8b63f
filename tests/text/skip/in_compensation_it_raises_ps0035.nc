(run with: --set #13001=5)
O1 (REF-5: not in G41)
G90 G41 D1 G01 X10. F100
Y20.
G31 Y30. (expect alarm PS0035)
M30

O1 (CALL-9: the fifth call in each other raises PS0122)
#100=1
G65 P2
M30
O2
G65 P3
O3
G65 P4
O4
G65 P5
O5
#100=5
G65 P6 (expect alarm PS0122)
O6
M99
(finally #100=5)

O1 (section 8: M08 before the motion, M09 after it)
G01 X1. F100 M09 M08
M30
(finally records: coolant flood; coolant off)

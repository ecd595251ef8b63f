O1 (Z-1.0/M08: both are executed)
G01 F100
Z-1.0/M08 (expect moves: line Z-1)
M30
(finally records: coolant flood)

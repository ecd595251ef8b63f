O1 (section 11.5)
T3 M06
S1200 M03
M08
G04 X0.5
M07
M09
S800 M04
M60
M30
(finally records: tool 3; spindle cw 1200; coolant flood; dwell 0.5; coolant mist; coolant off; spindle ccw 800; mcode 60)

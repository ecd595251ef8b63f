O1 (NUL-10: a vacant variable prints as 0)
DPRNT[A#1[20]B#1[22]]
M30
(finally prints A0B0.00)

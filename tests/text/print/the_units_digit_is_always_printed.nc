O1 (OUT-4: 0.5 in format 13)
#1=0.5
DPRNT[A#1[13]]
M30
(finally prints A0.500)

O1 (OUT-6: format 03)
#1=0.5
DPRNT[A#1[03]]
M30
(finally prints A.500)

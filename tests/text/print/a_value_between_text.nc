O1 (OUT-2: 1.5 in format 22)
#1=1.5
DPRNT[A*#1[22]*END]
M30
(finally prints A 1.50 END)

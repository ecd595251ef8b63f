O1 (OUT-2: + - / . and digits)
DPRNT[-----]
DPRNT[10+2/4.5]
M30
(finally prints -----)
(finally prints 10+2/4.5)

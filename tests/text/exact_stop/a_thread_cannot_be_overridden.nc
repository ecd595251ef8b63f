O1 (G-7)
M03 S500
G33 Z-10. F1.5 (expect moves: thread Z-10 fixed pass)
G61 Z-20. (expect moves: thread Z-20 fixed stop)
M30

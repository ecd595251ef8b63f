O1 (a thread that an axis cannot follow is refused whole)
M03 S5000
G33 Z-10. F5. (expect alarm SPINDLE_TOO_FAST)
M30

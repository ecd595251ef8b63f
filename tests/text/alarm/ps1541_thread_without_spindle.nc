O1 (PS1541: a thread needs a spindle speed)
G33 Z-10. F2. (expect alarm PS1541)
M30

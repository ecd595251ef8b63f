O1 (PS0204: Y1. between M29 and G74)
M29 S300
Y1.
G74 X0 Y0 Z-10. R-2. F300
M30
(finally alarm PS0204)

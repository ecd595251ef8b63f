s=100
gosub sq
end
sq:
if s<10 then return
move(0,0,0)
line(s,0,0);line(s,s,0);line(0,s,0);line(0,0,0) ' (expect warning LW0003 at line) (expect warning LW0003 at line) (expect warning LW0003 at line) (expect warning LW0003 at line)
s=s/2
gosub sq
s=s*2
return
' (finally counts line 16)
' (finally lines of 750)
' (finally s=100)

gosub deeper
end
deeper:
for a=1 to 2 ' (expect alarm LB0010 at for)
gosub deeper
next
return
